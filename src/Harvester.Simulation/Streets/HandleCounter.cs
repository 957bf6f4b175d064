namespace Harvester.Simulation.Streets;

/// <summary>Gives every entity a handle of its own, from 1 upwards.</summary>
internal sealed class HandleCounter
{
    private int _last;

    public int Next() => ++_last;
}
