namespace Harvester.Sessions.Faces;

/// <summary>The content of a table file: the valid rows, and why the others were rejected.</summary>
/// <param name="Table">A table of the valid rows.</param>
/// <param name="Problems">The rejected rows, in the order of the file.</param>
public sealed record FaceTableContent(FaceTable Table, IReadOnlyList<FaceTableProblem> Problems)
{
    /// <summary>Whether there was a header line; only the project's own format has one.</summary>
    public bool HasHeader { get; init; }
}
