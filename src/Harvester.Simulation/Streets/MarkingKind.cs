namespace Harvester.Simulation.Streets;

/// <summary>How a line on the road is painted.</summary>
internal enum MarkingKind
{
    /// <summary>White and unbroken, along the side of the carriageway.</summary>
    Edge,

    /// <summary>White and dashed, between lanes of one direction.</summary>
    LaneDashed,

    /// <summary>Yellow and unbroken, along a median.</summary>
    Centre,

    /// <summary>Two yellow unbroken lines side by side, between the directions where there is no median.</summary>
    CentreDouble,

    /// <summary>Yellow and dashed, between the directions of a small road.</summary>
    CentreDashed,
}
