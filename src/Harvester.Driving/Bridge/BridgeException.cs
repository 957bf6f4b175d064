using System;

namespace Harvester.Driving.Bridge;

/// <summary>A client has sent something that is no message; its line says what.</summary>
public sealed class BridgeException : Exception
{
    /// <summary>Makes one without a reason.</summary>
    public BridgeException()
    {
    }

    /// <summary>Makes one with a reason in one line.</summary>
    public BridgeException(string message)
        : base(message)
    {
    }

    /// <summary>Makes one with a reason and its cause.</summary>
    public BridgeException(string message, Exception innerException)
        : base(message, innerException)
    {
    }
}
