namespace Harvester.Driving.Bridge;

/// <summary>A client has sent something invalid; the message says what.</summary>
public sealed class BridgeException : Exception
{
    /// <summary>Creates an exception without a message.</summary>
    public BridgeException() { }

    /// <summary>Creates an exception with a message of one line.</summary>
    public BridgeException(string message)
        : base(message) { }

    /// <summary>Creates an exception with a message of one line and its cause.</summary>
    public BridgeException(string message, Exception innerException)
        : base(message, innerException) { }
}
