namespace Harvester.Capture.Harvesting;

/// <summary>How fast something moves in a tick, compared with the running game.</summary>
internal enum MotionPace
{
    /// <summary>It does not move.</summary>
    Still,

    /// <summary>It moves clearly slower than before the freeze.</summary>
    Creep,

    /// <summary>It moves as before the freeze.</summary>
    Full,
}
