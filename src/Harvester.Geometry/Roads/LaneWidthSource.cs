namespace Harvester.Geometry.Roads;

/// <summary>Where the width of a road's lanes comes from.</summary>
public enum LaneWidthSource
{
    /// <summary>The constant of ordinary roads.</summary>
    Constant,

    /// <summary>The constant of roads that the path data marks as narrow.</summary>
    NarrowConstant,

    /// <summary>Derived from the edges of this road that the game reported.</summary>
    Calibrated,

    /// <summary>Measured from the lines painted on this road, including both outer edges.</summary>
    Paint,

    /// <summary>
    /// Measured from some lines of this road: an outer edge is not, or all lines are on the road next to it. The other lanes and edges
    /// follow from these.
    /// </summary>
    PartlyPaint,
}
