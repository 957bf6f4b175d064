namespace Harvester.Datasets.Sessions;

/// <summary>Something that is wrong with a session.</summary>
/// <param name="File">The file of the session that says it.</param>
/// <param name="Line">The line in it, from 1; null when it concerns no line.</param>
/// <param name="Message">What is wrong.</param>
public sealed record SessionProblem(string File, int? Line, string Message)
{
    /// <summary>One line for people.</summary>
    public override string ToString() => Line is { } line ? $"{File}, line {line}: {Message}" : $"{File}: {Message}";
}
