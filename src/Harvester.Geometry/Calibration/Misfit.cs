namespace Harvester.Geometry.Calibration;

/// <summary>What best explains why sightings and a camera model disagree.</summary>
public enum Misfit
{
    /// <summary>Nothing systematic: the disagreement is that of noise, or of single sightings.</summary>
    Noise,

    /// <summary>The picture is stretched along one axis, as when the window's aspect ratio is not the one that was reported.</summary>
    Stretch,

    /// <summary>The camera stands elsewhere than was reported: near points are off by more than far ones.</summary>
    CameraPosition,

    /// <summary>The camera is rolled about its axis otherwise than was reported.</summary>
    CameraRoll,

    /// <summary>The lens bends the picture in a way that two radial terms cannot describe.</summary>
    LensShape,
}
