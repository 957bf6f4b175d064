namespace Harvester.Exports;

/// <summary>Whether parts, whole objects or both are exported. Parts are the faces of signs and the heads of traffic lights.</summary>
public enum PartSelection
{
    /// <summary>Faces and heads instead of their signs and lights; all other objects are whole.</summary>
    Faces,

    /// <summary>Whole objects and their parts.</summary>
    All,

    /// <summary>Whole objects only: a sign or light includes its post.</summary>
    None,

    /// <summary>Parts only.</summary>
    Only,
}
