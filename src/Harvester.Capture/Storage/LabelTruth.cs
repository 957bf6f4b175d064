namespace Harvester.Capture.Storage;

/// <summary>How well a label of a session is known. The names are those in session.json.</summary>
public enum LabelTruth
{
    /// <summary>The game reports it, and it is written as reported or computed from that without sampling.</summary>
    Exact,

    /// <summary>It is measured by rays, read from the image, or derived from incomplete data.</summary>
    Estimated,

    /// <summary>The session does not have it.</summary>
    Unknown,
}
