// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Elements of the page and how numbers look.

/** Makes an element. Attributes that start with "on" are listeners; children
 * are elements or text. */
function el(tag, attributes = {}, ...children) {
  const [name, ...classes] = tag.split(".");
  const element = document.createElement(name);
  setAttributes(element, classes, attributes);
  element.append(...children.flat().filter((child) => child !== null));
  return element;
}

/** The same for the elements of drawings. */
function svg(tag, attributes = {}, ...children) {
  const [name, ...classes] = tag.split(".");
  const element = document.createElementNS("http://www.w3.org/2000/svg", name);
  setAttributes(element, classes, attributes);
  element.append(...children.flat().filter((child) => child !== null));
  return element;
}

function setAttributes(element, classes, attributes) {
  element.classList.add(...classes);
  for (const [key, value] of Object.entries(attributes))
    if (key === "class")
      element.classList.add(...value.split(" ").filter(Boolean));
    else if (key.startsWith("on"))
      element.addEventListener(key.slice(2), value);
    else if (value !== false && value !== undefined)
      element.setAttribute(key, value === true ? "" : value);
}

const groups = new Intl.NumberFormat("en-US", { maximumFractionDigits: 0 });

/** 1234567 as 1,234,567. */
function count(value) {
  return groups.format(value);
}

/** 1234567 as 1.23 M. */
function short(value) {
  const units = ["", " k", " M", " G", " T"];
  let unit = 0;
  let scaled = value;
  while (Math.abs(scaled) >= 999.5 && unit < units.length - 1) {
    scaled /= 1000;
    unit += 1;
  }
  if (unit === 0)
    return Number.isInteger(scaled) ? String(scaled) : scaled.toPrecision(3);
  return scaled.toPrecision(3) + units[unit];
}

/** A part of a whole; what is not nothing never shows as 0. */
function percent(part, whole) {
  const share = whole === 0 ? 0 : part / whole;
  if (share === 0) return "0 %";
  if (Math.abs(share) < 0.0005) return "<0.1 %";
  return `${(share * 100).toFixed(1)} %`;
}

/** The last part of a path. */
function fileName(path) {
  return path.slice(path.lastIndexOf("/") + 1);
}

/** A function's name without parameters, template arguments and result. */
function shortName(name) {
  if (name.startsWith("(")) return name;
  let text = "";
  let depth = 0;
  const plain = name.replaceAll("(anonymous namespace)::", "");
  for (let i = 0; i < plain.length; i += 1) {
    const rest = plain.slice(i);
    const operator = /^operator(\(\)|<=>|<<=?|>>=?|->\*?|[<>]=?)/.exec(rest);
    if (operator && depth === 0) {
      text += operator[0];
      i += operator[0].length - 1;
    } else if (plain[i] === "<") depth += 1;
    else if (plain[i] === ">") depth -= 1;
    else if (plain[i] === "(" && depth === 0) break;
    else if (depth === 0) text += plain[i];
  }
  const conversion = text.indexOf("operator ");
  if (conversion >= 0) return text.slice(conversion).trim();
  return text.slice(text.trim().lastIndexOf(" ") + 1).trim() || name;
}

const tooltip = document.getElementById("tooltip");

/** Shows content beside the pointer. */
function showTooltip(event, ...content) {
  tooltip.replaceChildren(...content);
  tooltip.hidden = false;
  const { offsetWidth: width, offsetHeight: height } = tooltip;
  const right = event.clientX + 14 + width < window.innerWidth;
  const below = event.clientY + 14 + height < window.innerHeight;
  const left = right ? event.clientX + 14 : event.clientX - 14 - width;
  const top = below ? event.clientY + 14 : event.clientY - 14 - height;
  tooltip.style.left = `${Math.max(4, left)}px`;
  tooltip.style.top = `${Math.max(4, top)}px`;
}

function hideTooltip() {
  tooltip.hidden = true;
}

/** Lets an element show what content() gives while the pointer is over it. */
function withTooltip(element, content) {
  element.addEventListener("pointermove", (event) =>
    showTooltip(event, ...[content(event)].flat()));
  element.addEventListener("pointerleave", hideTooltip);
  return element;
}
