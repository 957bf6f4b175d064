namespace Harvester.Sessions.Files;

/// <summary>Less space is free on a disk than is to stay free. What was written before is whole, and can be continued.</summary>
public sealed class LowSpaceException : IOException
{
    /// <summary>Creates the exception.</summary>
    /// <param name="message">How much is free, and where.</param>
    public LowSpaceException(string message)
        : base(message) { }
}
