# resummations
