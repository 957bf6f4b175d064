namespace Harvester.Capture.Harvesting;

/// <summary>What a harvest is doing between two game ticks.</summary>
public enum HarvestPhase
{
    /// <summary>The ways of freezing the game are being compared, once at the start.</summary>
    MeasuringFreeze,

    /// <summary>Markers are shown and the camera model is held against them, once at the start.</summary>
    CheckingCalibration,

    /// <summary>No frame is due yet; the game runs.</summary>
    Waiting,

    /// <summary>The game is asked to stand still, and is watched until it does.</summary>
    Settling,

    /// <summary>The lag between the state read and the picture shown is being measured.</summary>
    Probing,

    /// <summary>Live mode: the state is read, its picture has not appeared yet.</summary>
    Following,

    /// <summary>Labels are being made, as far as the budget of a tick allows.</summary>
    Labelling,

    /// <summary>A frame is ready and the sink has no room; the game runs.</summary>
    WaitingForSink,

    /// <summary>Stopped by the caller or because all frames are taken.</summary>
    Stopped,

    /// <summary>Ended by a fault; the message is in the status.</summary>
    Faulted,
}
