namespace Harvester.Play.Setup;

/// <summary>Which features exclude each other, as sentences for the player, and when nothing may be drawn over the picture.</summary>
/// <param name="features">The features.</param>
internal sealed class FeatureRules(ModFeatures features)
{
    /// <summary>Whether a picture is grabbed now or so soon that nothing may be drawn over it.</summary>
    public bool IsPictureNear() =>
        features.Harvest.IsPictureNear
        || features.Calibration.IsOn
        || features.Drive.IsPictureNear
        || features.Signs.IsPictureNear
        || features.SelfTest.IsPictureNear;

    /// <summary>Whether a feature takes pictures, which show no radar.</summary>
    public bool TakesPictures() =>
        features.Harvest.IsOn || features.Calibration.IsOn || features.Signs.IsPictureNear || features.Drive.IsOn;

    /// <summary>Whether a feature may need the world frozen.</summary>
    public bool MayFreeze() => features.Harvest.IsOn || features.Calibration.IsOn || features.Drive.IsOn || features.SelfTest.IsOn;

    /// <summary>Whether a harvest, a drive, a plan or the self-test is running, which a pause of the game interrupts.</summary>
    public bool IsRunning() => features.Harvest.IsOn || features.Drive.IsOn || features.Plan.IsOn || features.SelfTest.IsOn;

    /// <summary>Why nothing that measures or drives can start now; null if it can.</summary>
    public string? MeasurementObstacle() =>
        features.SelfTest.IsOn ? "The self-test is running: wait for its end, or end it by its key."
        : features.Calibration.IsOn ? "The calibration is running: wait for its end."
        : features.Signs.IsOn ? "The survey of signs is running: wait for its end, or end it by its key."
        : null;

    /// <summary>Why no client can drive now; null if one can.</summary>
    public string? DriveObstacle() =>
        features.Plan.IsOn ? "A plan is running: end it by its key first."
        : features.Paint.IsOn ? "The survey of paint is running: end it by its key first."
        : features.Harvest.IsOn ? "End the harvest first."
        : MeasurementObstacle();

    /// <summary>Why no plan, self-test or calibration can start now; null if one can.</summary>
    public string? PlanObstacle() => features.Drive.IsOn ? "A client drives: end that first." : DriveObstacle();
}
