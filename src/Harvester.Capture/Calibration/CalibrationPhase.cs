namespace Harvester.Capture.Calibration;

/// <summary>What a calibration is doing between two game ticks.</summary>
public enum CalibrationPhase
{
    /// <summary>Waiting until the camera stands still and the picture shows it.</summary>
    Settling,

    /// <summary>Done; there is a result.</summary>
    Done,

    /// <summary>Ended without a result; there is a message.</summary>
    Failed,
}
