using System.Net.Sockets;

namespace Harvester.Driving.Bridge;

/// <summary>
/// Lets the network itself ask whether the other machine still answers, also while nothing is said, as in a world that stands: a machine
/// that was switched off or cut off never says that it goes.
/// </summary>
internal static class KeepAlive
{
    private const int QuietSeconds = 5;
    private const int SecondsBetweenQuestions = 1;
    private const int QuestionsWithoutAnswer = 5;

    // The same numbers on all systems; .NET Framework has no names for them.
    private const SocketOptionName Time = (SocketOptionName)3;
    private const SocketOptionName RetryCount = (SocketOptionName)16;
    private const SocketOptionName Interval = (SocketOptionName)17;

    /// <summary>Asks for it. A system that cannot be told how often asks at its own pace.</summary>
    public static void Ask(Socket socket)
    {
        socket.SetSocketOption(SocketOptionLevel.Socket, SocketOptionName.KeepAlive, true);
        try
        {
            socket.SetSocketOption(SocketOptionLevel.Tcp, Time, QuietSeconds);
            socket.SetSocketOption(SocketOptionLevel.Tcp, Interval, SecondsBetweenQuestions);
            socket.SetSocketOption(SocketOptionLevel.Tcp, RetryCount, QuestionsWithoutAnswer);
        }
        catch (SocketException)
        {
            // Windows before 10 (1709).
            return;
        }
    }
}
