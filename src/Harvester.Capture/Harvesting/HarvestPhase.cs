namespace Harvester.Capture.Harvesting;

/// <summary>What a harvest is doing between two game ticks.</summary>
public enum HarvestPhase
{
    /// <summary>Compares the freeze methods, once at the start.</summary>
    MeasuringFreeze,

    /// <summary>Checks the camera model by markers, once at the start.</summary>
    CheckingCalibration,

    /// <summary>Compares pictures of the frozen game with and without its display, once at the start.</summary>
    CheckingDisplay,

    /// <summary>No frame is due yet; the game runs.</summary>
    Waiting,

    /// <summary>On its way to the next place of a tour.</summary>
    Travelling,

    /// <summary>Waits until the game stands still.</summary>
    Settling,

    /// <summary>Measures the lag between state and picture.</summary>
    Probing,

    /// <summary>Live mode: the state has been read; its picture has not appeared yet.</summary>
    Following,

    /// <summary>Photographs the frozen world with objects hidden.</summary>
    Photographing,

    /// <summary>Computes labels, within the time budget of a tick.</summary>
    Labelling,

    /// <summary>A frame is ready and the sink has no room; the game runs.</summary>
    WaitingForSink,

    /// <summary>Stopped by the caller or because all frames are taken.</summary>
    Stopped,

    /// <summary>Ended by a fault; the message is in the status.</summary>
    Faulted,
}
