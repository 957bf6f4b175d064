using GTA.Hosting;

namespace GTA.UI;

/// <summary>Messages above the map.</summary>
public static class Notification
{
    /// <summary>Shows a message and returns its handle.</summary>
    public static int Show(string message, bool blinking = false)
    {
        ScriptThread.Require("a notification");
        GameHost.Current.Notify(message);
        return 1;
    }
}
