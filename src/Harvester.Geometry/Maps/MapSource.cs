namespace Harvester.Geometry.Maps;

/// <summary>Where a part of a map comes from.</summary>
public enum MapSource
{
    /// <summary>Derived from the road data.</summary>
    Derived,

    /// <summary>Measured in images.</summary>
    Measured,

    /// <summary>Known exactly, as in the simulated game.</summary>
    Known,
}
