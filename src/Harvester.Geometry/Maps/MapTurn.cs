namespace Harvester.Geometry.Maps;

/// <summary>Where a way through a junction leads.</summary>
public enum MapTurn
{
    /// <summary>Straight on: it bends by at most 35 degrees.</summary>
    Straight,

    /// <summary>To the left.</summary>
    Left,

    /// <summary>To the right.</summary>
    Right,
}
