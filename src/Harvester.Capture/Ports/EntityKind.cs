namespace Harvester.Capture.Ports;

/// <summary>The kinds of entities that a game lists.</summary>
public enum EntityKind
{
    /// <summary>Cars, trucks, motorcycles, bicycles and everything else that drives.</summary>
    Vehicle,

    /// <summary>People and animals.</summary>
    Ped,

    /// <summary>Movable and fixed objects, such as signs, traffic lights and lamps.</summary>
    Prop,
}
