namespace Harvester.Geometry.PixelMaps.Screens;

/// <summary>What a pixel of a screen shows in the picture of the object before it.</summary>
internal enum MatteState : byte
{
    /// <summary>Nothing is known: it is outside the screen, or a nearer screen hides it.</summary>
    Unknown,

    /// <summary>The screen.</summary>
    Screen,

    /// <summary>Something else that is in front of the screen.</summary>
    World,

    /// <summary>The same in the shadow of the object, or the object.</summary>
    Doubt,

    /// <summary>The object.</summary>
    Object,
}
