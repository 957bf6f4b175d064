namespace Harvester.Datasets.Exports;

/// <summary>Which objects are exported by what they are parts of: the face of a sign and the head of a traffic light are objects with a parent.</summary>
public enum PartSelection
{
    /// <summary>Objects of their own and parts of others.</summary>
    All,

    /// <summary>Objects of their own only: each thing is there once.</summary>
    None,

    /// <summary>Parts only: what a reader of signs and lights learns from.</summary>
    Only,
}
