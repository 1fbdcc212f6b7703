/// \p value as a share of \p whole.
float share(float value, float whole);
/// The shares of all values.
void shares(const float *values, int count, float whole, float *result);
