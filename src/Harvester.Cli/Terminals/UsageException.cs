using System;

namespace Harvester.Cli.Terminals;

/// <summary>The options do not go together or make no sense; found after the command line was parsed.</summary>
internal sealed class UsageException : Exception
{
    public UsageException(string message)
        : base(message)
    {
    }
}
