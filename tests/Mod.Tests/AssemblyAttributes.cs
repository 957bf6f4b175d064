// One game plays behind the stand-in at a time, as in the real process.
[assembly: CollectionBehavior(DisableTestParallelization = true)]
