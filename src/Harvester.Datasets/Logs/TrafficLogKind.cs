namespace Harvester.Datasets.Logs;

/// <summary>What moves in a log of traffic. The numbers are those of WOMD's object types.</summary>
internal enum TrafficLogKind
{
    /// <summary>A car, truck, bus, trailer or motorcycle, with its rider.</summary>
    Vehicle = 1,

    /// <summary>A person on foot.</summary>
    Pedestrian = 2,

    /// <summary>A bicycle with its rider.</summary>
    Cyclist = 3,
}
