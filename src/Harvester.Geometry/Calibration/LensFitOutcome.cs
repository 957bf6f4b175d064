namespace Harvester.Geometry.Calibration;

/// <summary>How fitting a lens ended.</summary>
public enum LensFitOutcome
{
    /// <summary>The lens is found.</summary>
    Fitted,

    /// <summary>Fewer sightings agree than <see cref="LensFitter.MinSightings"/>, or fewer than half of those given.</summary>
    TooFewSightings,

    /// <summary>
    /// The sightings do not determine the lens: for example, they lie in one place or on a circle about the image's middle.
    /// </summary>
    Undetermined,
}
