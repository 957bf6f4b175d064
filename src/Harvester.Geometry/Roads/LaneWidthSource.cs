namespace Harvester.Geometry.Roads;

/// <summary>Where the width of a road's lanes comes from.</summary>
public enum LaneWidthSource
{
    /// <summary>The constant of ordinary roads.</summary>
    Constant,

    /// <summary>The constant of roads that the path data calls narrow.</summary>
    NarrowConstant,

    /// <summary>Proven by the edges of this road that the game told.</summary>
    Calibrated,
}
