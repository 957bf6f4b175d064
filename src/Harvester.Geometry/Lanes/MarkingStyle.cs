namespace Harvester.Geometry.Lanes;

/// <summary>How a line is painted on a road.</summary>
public enum MarkingStyle
{
    /// <summary>One unbroken stripe.</summary>
    Solid,

    /// <summary>One stripe with gaps.</summary>
    Dashed,

    /// <summary>Two unbroken stripes side by side.</summary>
    DoubleSolid,
}
