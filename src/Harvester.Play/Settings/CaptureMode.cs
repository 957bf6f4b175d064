namespace Harvester.Play.Settings;

/// <summary>How picture and label come to be of one moment.</summary>
internal enum CaptureMode
{
    /// <summary>The game stands still for each frame.</summary>
    Freeze,

    /// <summary>The game goes on.</summary>
    Live,
}
