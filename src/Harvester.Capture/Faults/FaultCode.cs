namespace Harvester.Capture.Faults;

/// <summary>What went wrong or could not be checked. Each front end adds its own advice in terms of its options or settings.</summary>
public enum FaultCode
{
    /// <summary>The game, the screen or the disk failed.</summary>
    Failed,

    /// <summary>The image lags further behind the game than the limit allows.</summary>
    PictureLate,

    /// <summary>A live harvest needs the picture lag, but nothing moved from which to measure it.</summary>
    LagUnknown,

    /// <summary>The picture lag was not checked; the harvest goes on.</summary>
    LagUnchecked,

    /// <summary>The camera model differs from the markers by more than the limit.</summary>
    CameraModelOff,

    /// <summary>Too few markers are visible to check the camera model.</summary>
    MarkersHidden,

    /// <summary>No marker was visible, so the camera model was not checked; the harvest goes on.</summary>
    CameraUnchecked,

    /// <summary>The camera did not stand still for the markers, or the lens fitted to them was rejected.</summary>
    CalibrationFailed,

    /// <summary>No freeze method stops the world; the harvest goes on.</summary>
    NeverStill,

    /// <summary>The game does not hide entities while it is frozen, so that masks come from rays; the harvest goes on.</summary>
    NothingHidden,

    /// <summary>Something is drawn over the pictures; the harvest goes on.</summary>
    PicturesSpoiled,

    /// <summary>The game's display cannot be hidden while it is frozen; the harvest goes on.</summary>
    DisplayStays,

    /// <summary>Known colours come back from pictures as others; the harvest goes on.</summary>
    ColoursChanged,

    /// <summary>Further pictures of moments are missing, because they did not settle or could not be taken; the harvest goes on.</summary>
    PairsMissing,

    /// <summary>The session has used all object numbers.</summary>
    NumbersUsedUp,

    /// <summary>The camera does not come to the place of a view of the rig while the game is frozen.</summary>
    ViewNotShown,
}
