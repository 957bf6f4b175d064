namespace Harvester.Datasets.Exports;

/// <summary>
/// Whether parts, their parents or both are exported. The face of a sign and the head of a traffic light are parts.
/// </summary>
public enum PartSelection
{
    /// <summary>Faces and heads stand for their signs and lights, whose posts are no objects; everything else is whole.</summary>
    Faces,

    /// <summary>Whole objects and their parts.</summary>
    All,

    /// <summary>Whole objects only: a sign or light includes its post.</summary>
    None,

    /// <summary>Parts only.</summary>
    Only,
}
