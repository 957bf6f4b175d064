namespace Harvester.TestSupport;

/// <summary>The tests that share one harvest.</summary>
[CollectionDefinition(SimulatedSession.Collection)]
public sealed class SimulatedSessionGroup : ICollectionFixture<SimulatedSession>;
