namespace Harvester.Sessions.Reading;

/// <summary>A problem of a session or dataset.</summary>
/// <param name="File">The file with the problem.</param>
/// <param name="Line">Line number, from 1; null if the problem has no line.</param>
/// <param name="Message">The problem, a sentence.</param>
public sealed record SessionProblem(string File, int? Line, string Message)
{
    /// <summary>The problem as one line of text.</summary>
    public override string ToString() => Line is { } line ? $"{File}, line {line}: {Message}" : $"{File}: {Message}";
}
