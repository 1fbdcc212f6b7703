// The -W words, as clang's work, and `#pragma clang diagnostic`.

// DEFINE: %{run} = tpcc -ffast-math -fsyntax-only
// RUN: %{run} %s 2>&1 | FileCheck --check-prefixes=NONFINITE,INDEX,COUNT3 %s
// RUN: %{run} -Wno-tp-fp-nonfinite %s 2>&1 \
// RUN:   | FileCheck --check-prefixes=INDEX,COUNT1 %s
// RUN: %{run} -Wno-tp-fp-conversion %s 2>&1 \
// RUN:   | FileCheck --check-prefixes=NONFINITE,COUNT2 %s
// RUN: %{run} -Wno-tp-fp %s 2>&1 | count 0
// RUN: %{run} -Wno-tp-fp -Wtp-fp-conversion %s 2>&1 \
// RUN:   | FileCheck --check-prefixes=INDEX,COUNT1 %s
// RUN: %{run} -w %s 2>&1 | count 0

// RUN: not %{run} -Werror %s 2>&1 | FileCheck --check-prefix=ALL-ERRORS %s
// ALL-ERRORS-DAG: error: infinity {{.*}} [-Werror,-Wtp-fp-nonfinite]
// ALL-ERRORS-DAG: error: an index {{.*}} [-Werror,-Wtp-fp-conversion]
// RUN: not %{run} -Werror=tp-fp-conversion %s 2>&1 \
// RUN:   | FileCheck --check-prefixes=NONFINITE,INDEX-ERROR %s
// RUN: not %{run} -Werror -Wno-error=tp-fp-nonfinite %s 2>&1 \
// RUN:   | FileCheck --check-prefixes=NONFINITE,INDEX-ERROR %s
// RUN: %{run} -Werror -Wno-error=tp-fp %s 2>&1 \
// RUN:   | FileCheck --check-prefixes=NONFINITE,INDEX,COUNT3 %s
// NONFINITE: warning: infinity {{.*}} [-Wtp-fp-nonfinite]
// INDEX: warning: an index {{.*}} [-Wtp-fp-conversion]
// INDEX-ERROR: error: an index {{.*}} [-Werror,-Wtp-fp-conversion]
// COUNT1: 1 warning generated.
// COUNT2: 2 warnings generated.
// COUNT3: 3 warnings generated.

// Nothing is compiled after an error.
// RUN: rm -f %t.o
// RUN: not tpcc -ffast-math -Werror=tp-fp -c -o %t.o %s
// RUN: not ls %t.o

// In stock clang the words follow the plug-in's name.
// DEFINE: %{stock} = clang++ -fplugin=%tp_bin/../lib/TPFloatingPoint.so \
// DEFINE:   -ffast-math -fsyntax-only
// RUN: %{stock} %s 2>&1 | FileCheck --check-prefixes=NONFINITE,INDEX,COUNT3 %s
// RUN: %{stock} -fplugin-arg-tp-fp-Wno-tp-fp-nonfinite %s 2>&1 \
// RUN:   | FileCheck --check-prefixes=INDEX,COUNT1 %s
// RUN: not %{stock} -fplugin-arg-tp-fp-Werror=tp-fp-conversion %s 2>&1 \
// RUN:   | FileCheck --check-prefixes=NONFINITE,INDEX-ERROR %s
// RUN: not %{stock} -fplugin-arg-tp-fp-Wtp-fp-conversions %s 2>&1 \
// RUN:   | FileCheck --check-prefix=MISSPELT %s
// MISSPELT: error: unknown warning option '-Wtp-fp-conversions'; did you mean '-Wtp-fp-conversion'?
// tpcc has them once, even if it loads the plug-in.
// RUN: %{run} -fplugin=%tp_bin/../lib/TPFloatingPoint.so %s 2>&1 \
// RUN:   | FileCheck --check-prefixes=NONFINITE,INDEX,COUNT3 %s
// Without -fplugin= there is nothing to see.
// RUN: clang++ -fpass-plugin=%tp_bin/../lib/TPFloatingPoint.so \
// RUN:   -Wno-nan-infinity-disabled -Wno-unknown-warning-option -ffast-math \
// RUN:   -c -o %t.o %s 2>&1 | count 0

float loud() { return __builtin_inff(); }

#pragma clang diagnostic push
#pragma clang diagnostic ignored "-Wtp-fp-nonfinite"
float silenced() { return __builtin_inff(); }
#pragma clang diagnostic pop

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wtp-fp"
float silencedByGroup() { return __builtin_inff(); }
#pragma GCC diagnostic pop

#define SILENCE _Pragma("clang diagnostic ignored \"-Wtp-fp-nonfinite\"")
#pragma clang diagnostic push
SILENCE
float silencedByMacro() { return __builtin_inff(); }
#pragma clang diagnostic pop

float loudAgain() { return __builtin_inff(); }

extern int Counts[9];
void count(float X, float W) { ++Counts[int(X / W)]; }
