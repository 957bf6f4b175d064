namespace Harvester.Runs.Faults;

/// <summary>A run cannot be made as it is asked for: a setting, or several together, must be changed.</summary>
public class UsageException : Exception
{
    /// <summary>Creates the exception.</summary>
    /// <param name="message">What is wrong and what to change, in one line.</param>
    public UsageException(string message)
        : base(message) { }
}
