namespace Harvester.Cli.Terminals;

/// <summary>The command line is invalid in a way that the parser does not detect.</summary>
internal sealed class UsageException : Exception
{
    public UsageException(string message)
        : base(message) { }
}
