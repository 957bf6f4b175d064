namespace Harvester.Simulation.Rendering;

/// <summary>How the surface of a triangle reflects or emits light.</summary>
public enum Surface
{
    /// <summary>Dull, lit by sun and sky.</summary>
    Matte,

    /// <summary>Car paint: matte with a little of the sky reflected.</summary>
    Paint,

    /// <summary>Window glass: dark, with much of the sky reflected.</summary>
    Glass,

    /// <summary>A window with a lamp behind it: glass by day, its own colour at night.</summary>
    LitWindow,

    /// <summary>A lamp that is off by day, and matte then; at night it shines in its own colour.</summary>
    NightLamp,

    /// <summary>A lamp that is lit by day as well: always its own colour.</summary>
    Lamp,

    /// <summary>Ground: matte, with a fine grain so that large faces are not of one colour.</summary>
    Ground,

    /// <summary>Asphalt: ground that is patched and worn, holds water in rain, and has tracks through snow.</summary>
    Asphalt,

    /// <summary>Paint on a road: matte.</summary>
    Marking,
}
