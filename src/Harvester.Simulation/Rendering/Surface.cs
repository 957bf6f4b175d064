namespace Harvester.Simulation.Rendering;

/// <summary>How a triangle's surface takes and gives light.</summary>
public enum Surface
{
    /// <summary>Dull, lit by sun and sky.</summary>
    Matte,

    /// <summary>Car paint: as matte with a little of the sky mirrored.</summary>
    Paint,

    /// <summary>Window glass: dark, with much of the sky mirrored.</summary>
    Glass,

    /// <summary>A window with a lamp behind it: glass by day, its own colour by night.</summary>
    LitWindow,

    /// <summary>A lamp that is off by day and matte then, and shines in its own colour by night.</summary>
    NightLamp,

    /// <summary>A lamp that burns by day as well: its own colour whatever the light.</summary>
    Lamp,

    /// <summary>Ground: matte, with a fine grain so that large faces are not flat colour.</summary>
    Ground,
}
