namespace Harvester.Geometry.Calibration;

/// <summary>The most likely reason why sightings and a camera model disagree.</summary>
public enum Misfit
{
    /// <summary>No systematic reason: noise, or single wrong sightings.</summary>
    Noise,

    /// <summary>The picture is stretched along one axis, as when the window's aspect ratio is not the reported one.</summary>
    Stretch,

    /// <summary>The camera is not at the reported position: near points are off by more than far ones.</summary>
    CameraPosition,

    /// <summary>The camera's roll differs from the reported one.</summary>
    CameraRoll,

    /// <summary>The lens distorts the picture in a way that two radial terms cannot describe.</summary>
    LensShape,
}
