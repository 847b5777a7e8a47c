"""From a model to a verdict: jump values, margins, certificates, probabilities and redesigns of any model."""
