namespace Harvester.Capture.Faults;

/// <summary>
/// What went wrong, or could not be checked; each front end adds its own advice, in the words of its options or settings.
/// </summary>
public enum FaultCode
{
    /// <summary>The game, the screen or the disk failed.</summary>
    Failed,

    /// <summary>The image lags further behind the game than the limit allows.</summary>
    PictureLate,

    /// <summary>A live harvest needs the picture lag, and nothing that moved showed it.</summary>
    LagUnknown,

    /// <summary>The picture lag was not checked; the harvest goes on.</summary>
    LagUnchecked,

    /// <summary>The camera model differs from the markers by more than the limit.</summary>
    CameraModelOff,

    /// <summary>Too few markers are visible to check the camera model.</summary>
    MarkersHidden,

    /// <summary>No marker was visible, so the camera model was not checked; the harvest goes on.</summary>
    CameraUnchecked,

    /// <summary>The markers could not be shown to a camera that stands still, or the lens that they give is not to be trusted.</summary>
    CalibrationFailed,

    /// <summary>No freeze method stops the world; the harvest goes on.</summary>
    NeverStill,

    /// <summary>The session has used all object numbers.</summary>
    NumbersUsedUp,
}
