namespace Harvester.Geometry.PixelMaps.Screens;

/// <summary>What is known of a pixel of a screen.</summary>
internal enum MatteState : byte
{
    /// <summary>Outside the screen, or nothing is known: a nearer screen hides it.</summary>
    Unknown,

    /// <summary>The screen is seen past the object.</summary>
    Screen,

    /// <summary>Something else is in front of the screen, and of the object if that reaches there.</summary>
    World,

    /// <summary>Something else in front of the screen that changes as in a shadow, or the object.</summary>
    Doubt,

    /// <summary>The object.</summary>
    Object,
}
