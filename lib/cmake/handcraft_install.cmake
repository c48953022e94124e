# Install rules: filled by the runtime and the tools.
