namespace Harvester.Simulation.Tests.Rigs;

/// <summary>Tests that measure the whole process: they run when all others are over.</summary>
[CollectionDefinition(Name, DisableParallelization = true)]
public sealed class MeasuredAlone
{
    public const string Name = "Measured alone";
}
