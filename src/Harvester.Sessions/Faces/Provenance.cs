namespace Harvester.Sessions.Faces;

/// <summary>How the corners of a space were come by.</summary>
public enum Provenance
{
    /// <summary>Guessed from the standard size of such a sign; nobody has measured the model.</summary>
    Estimated,

    /// <summary>Computed from something measured, such as a bone of the model.</summary>
    Derived,

    /// <summary>Measured in the game.</summary>
    Measured,
}
