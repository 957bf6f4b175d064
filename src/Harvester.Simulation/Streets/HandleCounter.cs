namespace Harvester.Simulation.Streets;

/// <summary>Gives every entity its own handle, upwards from 1.</summary>
internal sealed class HandleCounter
{
    private int _last;

    public int Next() => ++_last;
}
