namespace Harvester.Sessions.Faces;

/// <summary>How the corners of a face were obtained.</summary>
public enum Provenance
{
    /// <summary>Estimated from the standard size of such a sign; the model was not measured.</summary>
    Estimated,

    /// <summary>Computed from a measured value, such as a bone of the model.</summary>
    Derived,

    /// <summary>Measured in the game.</summary>
    Measured,
}
