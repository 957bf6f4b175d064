namespace Harvester.Geometry.Lanes;

/// <summary>The colour of a line painted on a road.</summary>
public enum MarkingColour
{
    /// <summary>White.</summary>
    White,

    /// <summary>Yellow.</summary>
    Yellow,
}
