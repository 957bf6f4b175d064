namespace Harvester.Simulation.Traffic;

/// <summary>What the ego can hit.</summary>
public enum EgoContact
{
    /// <summary>A vehicle in traffic.</summary>
    Vehicle,

    /// <summary>A parked vehicle.</summary>
    Parked,

    /// <summary>A pedestrian.</summary>
    Pedestrian,
}
