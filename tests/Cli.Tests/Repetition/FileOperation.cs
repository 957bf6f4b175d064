namespace Harvester.Cli.Tests.Repetition;

/// <summary>An operation on a file or folder.</summary>
/// <param name="Kind">What it does, such as rename.</param>
/// <param name="Path">The path below the watched folder, without the random part of a temporary name.</param>
/// <param name="Number">How many of the same kind and path came before.</param>
internal sealed record FileOperation(string Kind, string Path, int Number)
{
    public static FileOperation None { get; } = new("", "", 0);

    public override string ToString() => $"{Kind} {Path} #{Number}";
}
