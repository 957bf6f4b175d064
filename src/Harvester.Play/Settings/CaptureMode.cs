namespace Harvester.Play.Settings;

/// <summary>How image and label are made to show the same moment.</summary>
internal enum CaptureMode
{
    /// <summary>The game is frozen for each frame.</summary>
    Freeze,

    /// <summary>The game keeps running.</summary>
    Live,
}
